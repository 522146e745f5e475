#include "playhouse/c/covariance.h"

#include "proxy.h"

ph_covariance ph_covariance_of_deviations(double x, double y, double a) {
  return (ph_covariance){.xx = x * x, .yy = y * y, .aa = a * a};
}

ph_covariance ph_covariance_of(const double cov[6]) {
  return (ph_covariance){cov[0], cov[1], cov[2], cov[3], cov[4], cov[5]};
}

void ph_wire_covariance(ph_covariance covariance, double cov[6]) {
  const double numbers[] = {covariance.xx, covariance.yy, covariance.aa,
                            covariance.xy, covariance.ya, covariance.xa};
  for (size_t i = 0; i < 6; ++i) cov[i] = numbers[i];
}

ph_status ph_insist_on_covariance(const ph_device *device, ph_covariance covariance, ph_error *error) {
  PH_INSIST_ON_FINITE(device, error, {"xx", covariance.xx}, {"yy", covariance.yy}, {"aa", covariance.aa},
                      {"xy", covariance.xy}, {"ya", covariance.ya}, {"xa", covariance.xa});
  return PH_OK;
}
