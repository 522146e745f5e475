#include "playhouse/app/tls_files.h"

#include "playhouse/app/whole_file.h"

namespace playhouse::app {
namespace {

constexpr std::size_t kPemBytes = 1u << 20;

}  // namespace

Result<std::shared_ptr<net::TlsIdentity>> read_tls_files(const Serving& serving) {
  if (serving.tls_cert.empty()) return std::shared_ptr<net::TlsIdentity>();
  const Result<std::string> certificates = read_file(serving.tls_cert, config::NamedBy::kPerson, kPemBytes);
  if (!certificates) return certificates.error();
  const Result<std::string> key = read_file(serving.tls_key, config::NamedBy::kPerson, kPemBytes);
  if (!key) return key.error();
  return net::TlsIdentity::of({serving.tls_cert, *certificates}, {serving.tls_key, *key});
}

Result<std::shared_ptr<net::TlsTrust>> read_tls_trust(const std::string& file) {
  if (file.empty()) return std::shared_ptr<net::TlsTrust>();
  const Result<std::string> certificates = read_file(file, config::NamedBy::kPerson, kPemBytes);
  if (!certificates) return certificates.error();
  return net::TlsTrust::of({file, *certificates});
}

}  // namespace playhouse::app
