model "column" {}
box "column" { from = {0, 0, 0}, to = {1*m, 1*m, 4*m}, size = 0.1*mm }
