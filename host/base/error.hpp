// The one exception type: something in the world (a file, a scene, a driver) is wrong. Programming errors are
// asserts instead.
#pragma once

#include <stdexcept>
#include <string>

namespace ajar {

// what() is one line a user can act on: "file: where: what (what to do)", without a trailing newline.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace ajar
