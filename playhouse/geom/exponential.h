#pragma once

/// exp from additions and multiplications only, like sin and cos in trig.h: the same bits with
/// every compiler and library.
/// Source: Cody-Waite reduction by multiples of ln 2, Taylor series on [-ln(2)/2, ln(2)/2].

namespace playhouse::geom {

/// Relative error below 1e-15 for results that are normal numbers; 0 for x below -700, and x is at most 700.
double exp(double x);

}  // namespace playhouse::geom
