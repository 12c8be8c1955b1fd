model "column" {}
os.execute("rm -rf results")
