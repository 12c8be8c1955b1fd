solid "open"     { file = "solid_open.off", size = 0.5 }
solid "turned"   { file = "solid_turned.off", size = 0.5 }
solid "twice"    { file = "solid_twice.off", size = 0.5 }
solid "shells"   { file = "solid_two_shells.off", size = 0.5 }
solid "flat"     { file = "solid_flat.off", size = 0.5 }
solid "crossing" { file = "solid_crossing.off", size = 0.5 }
solid "edge"     { file = "solid_edge.off", size = 0.5 }
solid "needle"   { file = "solid_needle.off", size = 0.5 }
solid "tiny"     { file = "solid_tiny.off", size = 0.2 }
solid "huge"     { file = "solid_small.off", unit = 1000*km, size = 1 }
