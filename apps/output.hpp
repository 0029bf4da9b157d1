#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

// The only path from the program to standard output and standard error, except for the progress bar. All text passes
// through printable_lines, so that untrusted text cannot control the terminal.

/// Prevents opened files from replacing standard streams that were closed on entry, and so from receiving the output.
/// Call this first.
void hold_closed_streams();

/// Prints on standard output. @throws Error (file) if writing fails, for example on a full disk.
void print_output(std::string_view text);

/// Prints a line on standard error. If that is closed or full, the line is lost; the exit code remains.
void print_message(std::string_view line) noexcept;

/// Prints the first of the lines as messages, each after `prefix`, and the number of the others.
void print_some(std::string_view prefix, const std::vector<std::string>& lines);

}  // namespace bumpfoil
