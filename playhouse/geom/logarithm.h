#pragma once

/// log10 from additions, multiplications and divisions only, as trig.h has sin and cos: the same bits with
/// every compiler and library.
/// Source: the mantissa in [sqrt(1/2), sqrt(2)), and twice the series of artanh((m - 1) / (m + 1)).

namespace playhouse::geom {

/// Of a positive number that is not denormal; error below 1e-15 of 1 and of the logarithm.
double log10(double x);

}  // namespace playhouse::geom
