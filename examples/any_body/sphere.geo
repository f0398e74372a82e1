// A sphere of radius 10 mm; lengths in mm.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 10};
