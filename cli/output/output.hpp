#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stoss::cli {

/// A file that could not be written or read; the command exits with 4.
class OutputError : public std::runtime_error {
 public:
  /// @param reason errno, or 0 where the system has not refused
  explicit OutputError(const std::string& text, int reason = 0) : std::runtime_error(text), reason_(reason) {}

  [[nodiscard]] int reason() const { return reason_; }

 private:
  int reason_;
};

/// Bytes of a file name that a message repeats.
inline constexpr std::size_t longest_path = 240;

/// @param path "" for stdout
/// @throws OutputError
[[noreturn]] void cannot_write(const std::string& path, std::string_view why);
[[noreturn]] void cannot_write(const std::string& path, int reason);

/// What a name leads to, also where nothing is there yet.
[[nodiscard]] std::filesystem::path behind_links(std::filesystem::path path);

class Beside;

/// A regular file that is to be written, locked against other processes for as long as the target lives.
class Target {
 public:
  /// Locks the file, or finds that one can be made; changes nothing.
  /// @throws OutputError for what is no regular file or cannot be written, and while another process writes it
  explicit Target(const std::string& path);
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target();

  /// Makes the file and locks it where there is none. It goes again with the target unless something is written.
  void make();

  /// Makes a file beside it, and removes it. @throws OutputError where `prepare` could make none
  void require_room() const;

  /// Adds the text to a file beside it, which `replace` will put in its place. @throws OutputError
  void prepare(const std::string& text);

  /// Puts a file with what was prepared, and this text, in its place as a whole, or leaves it as it was.
  /// @throws OutputError
  void replace(const std::string& text);

  /// Cuts the file off after `size` bytes and adds the text, or nothing of it. @throws OutputError also where another
  /// process has replaced, removed or changed it: what would be lost is then in a new file beside it
  void extend(std::uintmax_t size, const std::string& text);

  /// Adds the text at the end of what was written, or nothing of it. @throws OutputError
  void add(const std::string& text) { extend(size_, text); }

  /// Whether the file is there and has nothing to lose.
  [[nodiscard]] bool is_empty() const;

  /// @throws OutputError as `extend`
  void close();

  /// Of the file as it is now; nullptr where there is none.
  [[nodiscard]] std::FILE* stream() const { return stream_.get(); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
  };

  void hold(int descriptor, int trial = 0);

  /// @param more what was to be added after the first `size` bytes
  void require_unchanged(std::uintmax_t size, const std::string& more);

  /// Finds whether the file has grown by what was added at its end, and by nothing else.
  void require_alone(const std::string& added);

  std::string path_;            // as the user wrote it
  std::filesystem::path file_;  // behind links
  std::unique_ptr<std::FILE, Close> stream_;
  std::unique_ptr<Beside> beside_;
  std::uintmax_t size_ = 0;  // of the file
  bool made_ = false;
};

/// A file, or stdout when the path is empty or "-". Every write is checked. A file stays as it was, or does not appear,
/// until what takes its place is on the disk.
class Output {
 public:
  enum class Use {
    whole,   ///< the file is replaced when the output is closed; much is prepared beside it
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
