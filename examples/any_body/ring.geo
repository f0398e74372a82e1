// A ring around z, 60 mm wide outside, 10 mm high: its profile, turned.
SetFactory("OpenCASCADE");
DefineConstant[ thickness = 4 ];
Rectangle(1) = {30 - thickness, -5, 0, thickness, 10};
Rotate{ {1, 0, 0}, {0, 0, 0}, Pi/2 }{ Surface{1}; }
Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Surface{1}; }
Recursive Delete{ Surface{1}; } // what is not of the volume
