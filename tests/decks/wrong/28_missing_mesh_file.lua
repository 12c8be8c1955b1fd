model "column" {}
import_mesh "dam" { file = "no_such_mesh.msh" }
import_mesh { file = "/dev/zero" }
import_mesh { file = "../../../../../../../../../dev/zero" }
