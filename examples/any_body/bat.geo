// A bat of 85 cm along z, its far end at z = 0, in mm: the profile on one side, turned around z. The
// barrel is an arc of radius 2 m, thickest (66 mm) at z = 110, to z = 300; the handle is 24 mm thick.
SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {22, 0, 0};
Point(3) = {-1967 + Sqrt(2000^2 - 100^2), 0, 10};
Point(4) = {-1967, 0, 110};
Point(5) = {-1967 + Sqrt(2000^2 - 190^2), 0, 300};
Point(6) = {17, 0, 390};
Point(7) = {13.5, 0, 500};
Point(8) = {12, 0, 650};
Point(9) = {12.5, 0, 800};
Point(10) = {22, 0, 835}; // the knob
Point(11) = {22, 0, 845};
Point(12) = {0, 0, 850};
Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 4, 5};
Spline(4) = {5, 6, 7, 8, 9};
Line(5) = {9, 10};
Line(6) = {10, 11};
Line(7) = {11, 12};
Line(8) = {12, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};
Plane Surface(1) = {1};
Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Surface{1}; }
Recursive Delete{ Surface{1}; Point{4, 6:8}; } // what is not of the volume
