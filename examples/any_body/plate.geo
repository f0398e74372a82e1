// A plate 60 thicknesses wide: 300 x 300 x 5 mm.
SetFactory("OpenCASCADE");
Box(1) = {-150, -150, -2.5, 300, 300, 5};
