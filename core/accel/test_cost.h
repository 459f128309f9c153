// What a ray's test against an object costs, about, in units of five instructions as valgrind
// counts them. For decisions by counts: the same on every machine, and good to a factor of two.
// Pure, any number of threads.
#pragma once

namespace lentray::core {

class Object;

/// Of all primitives together: CSG asks most of its parts.
double test_cost(const Object& object);

}  // namespace lentray::core
