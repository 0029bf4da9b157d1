#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

// The only way from the program to standard output and standard error, but for the progress bar. Whatever texts of
// others hold, nothing steers the terminal: all of it is made printable_lines.

/// Keeps files that are opened from taking the place of standard streams that were closed on entry, where they would
/// receive what is printed. To be called first.
void hold_closed_streams();

/// Prints on standard output. @throws Error (file) if it cannot take it, a full disk for one.
void print_output(std::string_view text);

/// Prints a line on standard error. Where that is closed or full the line is lost: the exit code still tells.
void print_message(std::string_view line) noexcept;

/// Prints the first of the lines as messages, each behind `prefix`, and how many there are beside.
void print_some(std::string_view prefix, const std::vector<std::string>& lines);

}  // namespace bumpfoil
