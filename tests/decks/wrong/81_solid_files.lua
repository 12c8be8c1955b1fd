solid "text"    { file = "solid_text.stl", size = 0.5 }
solid "missing" { file = "no_such.stl", size = 0.5 }
solid "mesh"    { file = "inverted.msh", size = 0.5 }
