model "dam" {}
extrude "dam" {
  section = { {0,0}, {48*m,0}, {8*m,50*m}, {8*m,60*m}, {0,60*m} }, length = 12*m, size = 4*m,
  holes = { {4*m,4*m}, {6*m,4*m}, {5*m,6*m} },
}
extrude "rock" {
  section = { {-60*m,-60*m}, {108*m,-60*m}, {108*m,0}, {-60*m,0} }, length = 12*m, size = 8*m,
  holes = { { {4*m,-4*m}, {6*m,4*MPa}, {5*m} } },
}
