// A coin, 25 mm wide and 2 mm thick, with a half-round rim: the profile on one side, turned around z.
SetFactory("OpenCASCADE");
Point(1) = {0, 0, -1};
Point(2) = {11.5, 0, -1};
Point(3) = {11.5, 0, 0};
Point(4) = {11.5 + Sqrt(0.5), 0, Sqrt(0.5)};
Point(5) = {11.5, 0, 1};
Point(6) = {0, 0, 1};
Line(1) = {1, 2};
Circle(2) = {2, 3, 4};
Circle(3) = {4, 3, 5};
Line(4) = {5, 6};
Line(5) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Surface{1}; }
Recursive Delete{ Surface{1}; Point{3}; } // what is not of the volume
