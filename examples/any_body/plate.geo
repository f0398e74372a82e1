// A plate 60 thicknesses wide, 300 x 300 x 5 mm, for the point in the middle of its upper face: layers
// of tetrahedra around a block of 36 x 36 mm, in which they grow from 0.15 mm at the point.
// Two meshes of it, also with -setnumber coarser 1.4: gmsh -3 -order 2 plate.geo -o plate.msh
DefineConstant[ coarser = 1 ];
layers = coarser > 1 ? 1 : 2;
wide = 150;
inner = 18;
half = 2.5;
For k In {0:1}
  s = k ? inner : wide;
  Point(4*k + 1) = {-s, -s, half};
  Point(4*k + 2) = {s, -s, half};
  Point(4*k + 3) = {s, s, half};
  Point(4*k + 4) = {-s, s, half};
  For i In {1:4}
    Line(4*k + i) = {4*k + i, 4*k + i%4 + 1};
  EndFor
  Curve Loop(k + 1) = {4*k + 1:4*k + 4};
EndFor
Plane Surface(1) = {1, 2};
Plane Surface(2) = {2};
frame[] = Extrude{0, 0, -2*half}{ Surface{1}; Layers{layers}; };
// frame[]: its lower face, itself, the outer sides, the inner sides
For i In {6:9}
  edges[] = Boundary{ Surface{frame[i]}; };
  For j In {0:3}
    p[] = PointsOf{ Line{Fabs(edges[j])}; };
    z0[] = Point{p[0]};
    z1[] = Point{p[1]};
    If (z0[2] < 0 && z1[2] < 0)
      lower[] += Fabs(edges[j]);
    EndIf
  EndFor
EndFor
Curve Loop(100) = {lower[]};
Plane Surface(100) = {100};
Surface Loop(100) = {2, 100, frame[6], frame[7], frame[8], frame[9]};
Volume(100) = {100};
Field[1] = MathEval;
Field[1].F = Sprintf("%g*(0.15 + 0.25*(Sqrt(x^2 + y^2 + (z - %g)^2 + 1.8^2) - 1.8))", coarser, half);
Background Field = 1;
Mesh.MeshSizeMax = 8*coarser;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Algorithm = 6;
