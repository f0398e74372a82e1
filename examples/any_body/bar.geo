// A round bar along x with hemispherical ends: radius 5 mm, length 100 mm.
SetFactory("OpenCASCADE");
Cylinder(1) = {-45, 0, 0, 90, 0, 0, 5};
Sphere(2) = {-45, 0, 0, 5};
Sphere(3) = {45, 0, 0, 5};
BooleanUnion{ Volume{1}; Delete; }{ Volume{2, 3}; Delete; }
