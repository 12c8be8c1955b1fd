model "column" {}
height = 4*m
