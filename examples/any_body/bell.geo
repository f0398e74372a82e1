// A bell of bronze, 80 mm high and 100 mm wide at its mouth: the profile on one side, turned around
// the axis z. Its wall has 8 mm, its sound bow 10 mm; a hole in the crown holds it.
SetFactory("OpenCASCADE");
Point(1) = {8, 0, 80};        // outside, from the crown down
Point(2) = {18, 0, 79};
Point(3) = {28, 0, 73};
Point(4) = {33, 0, 60};
Point(5) = {36, 0, 42};
Point(6) = {41, 0, 26};
Point(7) = {40 + 10*Cos(Pi/4.5), 0, 9 + 10*Sin(Pi/4.5)}; // the sound bow: an arc of radius 10
Point(8) = {40, 0, 9};
Point(9) = {40 + 10*Cos(Pi/3.6), 0, 9 - 10*Sin(Pi/3.6)};
Point(10) = {41.5, 0, 1};     // inside, up again
Point(11) = {40.2, 0, 9};
Point(12) = {34.5, 0, 21.5};
Point(13) = {28.3, 0, 39.5};
Point(14) = {25.1, 0, 58.5};
Point(15) = {21, 0, 67};
Point(16) = {15, 0, 71};
Point(17) = {8, 0, 72};
Spline(1) = {1, 2, 3, 4, 5, 6, 7};
Circle(2) = {7, 8, 9};
Line(3) = {9, 10};
Spline(4) = {10, 11, 12, 13, 14, 15, 16, 17};
Line(5) = {17, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Extrude{ {0, 0, 1}, {0, 0, 0}, 2*Pi }{ Surface{1}; }
Recursive Delete{ Surface{1}; Point{2:6, 8, 11:16}; } // what is not of the volume
