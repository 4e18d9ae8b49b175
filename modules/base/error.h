// The one exception type of Bole. It names what was found, what was needed and what to do; it is handled once, at the
// edge (command line, desktop, vtkBoleStage), which turns its kind into an exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace bole {

enum class ErrorKind {
  failed,     // the work itself went wrong: exit code 1
  bad_input,  // a file, option or document cannot be used as it is: exit code 2
  cancelled   // the user asked for it: exit code 3
};

class Error : public std::runtime_error {
 public:
  // `found` says what was met ("frame 12 has 3 points"), `needed` what would have served, `hint` what the user can do.
  // Either of the last two may be empty.
  Error(ErrorKind kind, std::string found, std::string needed = {}, std::string hint = {});

  // The same error with the place it came from ("stems.fit", "scan.pcap:12") in front of the message.
  Error at(const std::string& place) const;

  ErrorKind kind() const { return kind_; }
  int exit_code() const;
  const std::string& place() const { return place_; }
  const std::string& found() const { return found_; }
  const std::string& needed() const { return needed_; }
  const std::string& hint() const { return hint_; }

 private:
  Error(ErrorKind kind, std::string place, std::string found, std::string needed, std::string hint);
  ErrorKind kind_;
  std::string place_, found_, needed_, hint_;
};

// Shorthands for the two common kinds.
Error bad_input(std::string found, std::string needed = {}, std::string hint = {});
Error failure(std::string found, std::string needed = {}, std::string hint = {});

}  // namespace bole
