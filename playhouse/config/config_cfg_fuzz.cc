/// Any bytes as a configuration file: loads or fails with a text, and every accessor takes every field.

#include <cstdint>
#include <cstdlib>

#include "playhouse/config/cfg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::config;
  MemoryFiles files({{"c/more.inc", "define robot driver ( name \"stage\" )\n"}});
  const auto cfg = load_cfg_text(std::string(reinterpret_cast<const char*>(bytes), size), "c/t.cfg", files);
  if (!cfg) {
    if (cfg.error().text.empty()) std::abort();
    return 0;
  }
  for (const CfgSection& driver : cfg->drivers) {
    if (driver.addresses("provides").size() != driver.count("provides")) std::abort();
    (void)driver.unread();
    for (const char* key : {"model", "rate", "a", "spose[0]"}) {
      (void)driver.integer(key, 0);
      (void)driver.angle(key, 0, 1);
      (void)driver.flag(key, false);
      (void)driver.filename(key, "");
      (void)driver.fault();
    }
  }
  return 0;
}
