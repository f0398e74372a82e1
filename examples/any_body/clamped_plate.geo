// A plate, 120 × 80 mm and 10 mm thick, whose rim is held; lengths in mm.
SetFactory("OpenCASCADE");
Box(1) = {-60, -40, -5, 120, 80, 10};
Physical Surface("rim") = {1, 2, 3, 4};
Physical Volume("plate") = {1};
