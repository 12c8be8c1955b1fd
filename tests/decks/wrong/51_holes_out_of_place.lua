model "dam" {}
extrude "dam" {
  section = { {0,0}, {48*m,0}, {8*m,50*m}, {8*m,60*m}, {0,60*m} }, length = 12*m, size = 4*m,
  holes = { { {40*m,40*m}, {42*m,40*m}, {41*m,43*m} }, { {0,4*m}, {2*m,4*m}, {2*m,7*m}, {0,7*m} } },
}
