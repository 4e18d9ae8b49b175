#include "base/student_t.h"

#include <boost/math/distributions/students_t.hpp>
#include <limits>

namespace bole {

double student_975(double freedom) {
  if (!(freedom > 0)) return std::numeric_limits<double>::quiet_NaN();
  return boost::math::quantile(boost::math::students_t(freedom), 0.975);
}

}  // namespace bole
