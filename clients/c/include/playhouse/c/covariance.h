#ifndef PLAYHOUSE_C_COVARIANCE_H
#define PLAYHOUSE_C_COVARIANCE_H

#ifdef __cplusplus
extern "C" {
#endif

/** Covariance of a pose in the plane, of x, y (m) and a (rad): xx, yy, aa are the variances. */
typedef struct ph_covariance {
  double xx, yy, aa, xy, ya, xa;
} ph_covariance;

/** That of independent errors with these standard deviations, in m, m and rad. */
ph_covariance ph_covariance_of_deviations(double x, double y, double a);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_COVARIANCE_H */
