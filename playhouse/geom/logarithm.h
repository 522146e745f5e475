#pragma once

/// log10 from additions, multiplications and divisions only, like sin
/// and cos in trig.h: the same bits with every compiler and library.
/// Source: the mantissa in [sqrt(1/2), sqrt(2)), and twice the series of artanh((m - 1) / (m + 1)).

namespace playhouse::geom {

/// Needs a positive normal number; error below 1e-15, absolute and relative to the logarithm.
double log10(double x);

}  // namespace playhouse::geom
