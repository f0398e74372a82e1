// A beam along x, 200 x 20 x 10 mm, to be struck on its upper face.
SetFactory("OpenCASCADE");
Box(1) = {-100, -10, -5, 200, 20, 10};
