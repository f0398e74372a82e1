// A hollow sphere, radii 8 and 10 mm.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 10};
Sphere(2) = {0, 0, 0, 8};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
