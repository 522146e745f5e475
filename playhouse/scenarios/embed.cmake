# cmake -DFOLDER=... -DFILES=a;b -DOUT=embedded.cc -P embed.cmake
# Writes a C++ file that holds the bytes of FILES; playhouse/scenarios/embedded.h declares it.
set(TEXT "#include \"playhouse/scenarios/embedded.h\"\n\nnamespace playhouse::scenarios {\n\n")
string(APPEND TEXT "std::map<std::string, std::string> embedded_files() {\n  std::map<std::string, std::string> files;\n")
set(NUMBER 0)
foreach(FILE ${FILES})
  file(READ ${FOLDER}/${FILE} BYTES HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," BYTES "${BYTES}")
  string(APPEND TEXT "  static const unsigned char bytes${NUMBER}[] = {${BYTES}};\n")
  string(APPEND TEXT "  files.emplace(\"${FILE}\", std::string(reinterpret_cast<const char*>(bytes${NUMBER}), sizeof bytes${NUMBER}));\n")
  math(EXPR NUMBER "${NUMBER} + 1")
endforeach()
string(APPEND TEXT "  return files;\n}\n\n}  // namespace playhouse::scenarios\n")
file(WRITE ${OUT} "${TEXT}")
