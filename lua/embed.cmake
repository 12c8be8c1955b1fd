# Writes OUTPUT: a C++ source with every lua/*.lua as text, by name.
file(GLOB scripts ${FOLDER}/*.lua)
set(entries "")
foreach(script ${scripts})
  get_filename_component(name ${script} NAME_WE)
  file(READ ${script} text)
  string(APPEND entries "    {\"${name}\", R\"ashlar(${text})ashlar\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"script/sandbox.hpp\"

const std::map<std::string, std::string>& ashlar::bundled_scripts() {
  static const std::map<std::string, std::string> all = {
${entries}  };
  return all;
}
")
