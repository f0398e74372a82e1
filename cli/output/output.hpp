#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "output/target.hpp"

namespace stoss::cli {

/// A file, or stdout when the path is empty or "-". Every write is checked. A file stays as it was, or does not appear,
/// until what takes its place is on the disk.
class Output {
 public:
  enum class Use {
    whole,   ///< the file is replaced when the output is closed
    rows,    ///< it is replaced by the first row, and grows row by row
    resume,  ///< its content may be read; it is cut off by the first row after `keep`, and grows row by row
  };

  /// Changes nothing, but that a file of rows that is not there is made, empty, to be locked.
  /// @throws OutputError also while another process writes the file
  explicit Output(const std::string& path, Use use = Use::whole);

  /// How many bytes of a file to resume stay.
  void keep(std::uintmax_t size) { kept_ = size; }

  void write(const std::string& text) { pending_ += text; }

  /// Ends a row. @throws OutputError; Interrupted
  void end_row();

  void close();

  [[nodiscard]] const std::string& path() const { return path_; }

  /// For reading what is there, before the first row.
  [[nodiscard]] std::FILE* stream() const { return target_ ? target_->stream() : stdout; }

 private:
  void put(bool grows);

  std::string path_;
  Use use_;
  std::unique_ptr<Target> target_;  // of a file
  std::uintmax_t kept_ = 0;
  std::string pending_;  // until a row ends
  bool begun_ = false;
};

/// Whether two outputs would go to the same place.
[[nodiscard]] bool same_output(const std::string& a, const std::string& b);

}  // namespace stoss::cli
