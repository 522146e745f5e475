/// The parts of standalone Asio that are not templates, compiled here once (ASIO_SEPARATE_COMPILATION in CMakeLists.txt).

#include <asio/impl/src.hpp>
