# Writes OUT, a C++ file that holds every file under PAGE byte for byte (and its .gz beside it, where there is one).
set(types html=text/html js=text/javascript css=text/css txt=text/plain svg=image/svg+xml png=image/png ico=image/x-icon
          json=application/json woff2=font/woff2)

function(type_of name result)
  set(${result} "application/octet-stream" PARENT_SCOPE)
  get_filename_component(ending "${name}" LAST_EXT)
  string(REGEX REPLACE "^\\." "" ending "${ending}")
  foreach(type IN LISTS types)
    if(type MATCHES "^${ending}=(.*)$")
      set(found "${CMAKE_MATCH_1}")
      if(found MATCHES "^text/")
        string(APPEND found "; charset=utf-8")
      endif()
      set(${result} "${found}" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Puts a file's bytes between two symbols.
function(bytes_of symbol path)
  string(APPEND data "asm(\".pushsection .rodata,\\\"a\\\"\\n.global ${symbol}\\n${symbol}: .incbin \\\"${path}\\\"\\n\"\n"
                     "    \".global ${symbol}_end\\n${symbol}_end: .byte 0\\n.popsection\");\n"
                     "extern \"C\" const char ${symbol}[], ${symbol}_end[];\n")
  set(data "${data}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE names RELATIVE ${PAGE} ${PAGE}/*)
list(FILTER names EXCLUDE REGEX "\\.gz$")
list(SORT names)
set(data "")
set(entries "")
set(count 0)
foreach(name IN LISTS names)
  type_of("${name}" type)
  file(SHA256 ${PAGE}/${name} hash)
  string(SUBSTRING ${hash} 0 16 hash)
  set(symbol playhouse_page_${count})
  bytes_of(${symbol} ${PAGE}/${name})
  set(gzip "{}")
  if(EXISTS ${PAGE}/${name}.gz)
    bytes_of(${symbol}_gz ${PAGE}/${name}.gz)
    set(gzip "bytes(${symbol}_gz, ${symbol}_gz_end)")
  endif()
  string(APPEND entries "      {\"/${name}\", \"${type}\", \"W/\\\"${hash}\\\"\",\n"
                        "       bytes(${symbol}, ${symbol}_end), ${gzip}},\n")
  math(EXPR count "${count} + 1")
endforeach()

set(body "  return {};\n")
if(count GREATER 0)
  set(body "  static const PageFile files[] = {\n${entries}  };\n  return files;\n")
endif()
file(WRITE ${OUT} "// Made by web/embed.cmake from the built page.\n\n#include \"playhouse/web_server/page_files.h\"\n\n${data}
namespace playhouse::web_server {

[[maybe_unused]] static std::string_view bytes(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

std::span<const PageFile> page_files() {
${body}}

}  // namespace playhouse::web_server
")
