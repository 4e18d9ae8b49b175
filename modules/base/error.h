// The one exception type of Bole. It names what was found, what was needed and what to do; it is handled once, at the
// edge (command line, desktop, vtkBoleStage), which turns its kind into an exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace bole {
inline namespace base {

enum class ErrorKind {
  failed,     // the work itself went wrong: exit code 1
  bad_input,  // a file, option or document cannot be used as it is: exit code 2
  cancelled   // the user asked for it: exit code 3
};

class Error : public std::runtime_error {
 public:
  // `what_found` says what was met ("frame 12 has 3 points"), `what_needed` what would have served, `what_to_do` the
  // remedy. Either of the last two may be empty.
  explicit Error(ErrorKind error_kind, std::string what_found, std::string what_needed = {},
                 std::string what_to_do = {});

  // The same error with the place it came from ("stems.fit", "scan.pcap:12") in front of the message.
  Error at(const std::string& where) const;

  ErrorKind kind() const { return kind_; }
  int exit_code() const;
  const std::string& place() const { return parts_.place; }
  const std::string& found() const { return parts_.found; }
  const std::string& needed() const { return parts_.needed; }
  const std::string& hint() const { return parts_.hint; }

 private:
  struct Parts {
    std::string place, found, needed, hint;
  };
  Error(ErrorKind error_kind, Parts parts);
  static std::string compose(const Parts& parts);
  ErrorKind kind_;
  Parts parts_;
};

// Shorthands for the two common kinds.
Error bad_input(std::string found, std::string needed = {}, std::string hint = {});
Error failure(std::string found, std::string needed = {}, std::string hint = {});

}  // namespace base
}  // namespace bole
