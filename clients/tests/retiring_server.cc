// The real server for tests of the client library in Python: says its address, then does what each line of
// its input says ("add INDEX", "publish INDEX X", "retire INDEX") and answers "done".

#include "retiring_server.h"

#include <iostream>
#include <sstream>
#include <string>

#include "playhouse/base/log.h"

int main() {
  playhouse::log::open(0);  // its lines go elsewhere
  playhouse::RetiringServer server;
  std::cout << server.address() << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string verb;
    std::uint16_t index = 0;
    double x = 0;
    words >> verb >> index >> x;
    if (verb == "add") server.add(index);
    if (verb == "publish") server.publish(index, x);
    if (verb == "retire") server.retire(index);
    std::cout << "done" << std::endl;
  }
}
