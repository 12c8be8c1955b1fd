model "column" {}
box "column" { from = {0, 0, 0}, to = {1, 1, 4}, cells = {1, 1, 4}
surface "foot" { of = "column", side = "bottom" }
