#include "report.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>

#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::string full_precision(const Value& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

/// To the six digits that fit a table.
std::string for_reading(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  return full_precision(value);
}

nlohmann::ordered_json to_json(const Value& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

std::string header(const Provenance& provenance) {
  std::string text = fmt::format("# stoss {}: {}\n# command: {}\n", version(), provenance.schema, provenance.command);
  for (const auto& [key, value] : provenance.inputs.items()) {
    text += fmt::format("# {}: {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

/// Pads on the left to a width in characters (UTF-8 continuation bytes do not count).
std::string right_aligned(const std::string& text, int width) {
  int length = 0;
  for (const char c : text) length += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  return std::string(static_cast<std::size_t>(std::max(width - length, 0)), ' ') + text;
}

}  // namespace

Output::Output(const std::string& path)
    : path_(path == "-" ? "" : path),
      file_(path_.empty() ? stdout : std::fopen(path.c_str(), "w"), path_.empty() ? std::fflush : std::fclose) {
  if (!file_) throw OutputError(fmt::format("output: cannot write '{}': {}", path, std::strerror(errno)));
}

void Output::fail() const {
  throw OutputError(fmt::format("output: cannot write {}: {}", path_.empty() ? "to stdout" : "'" + path_ + "'",
                                std::strerror(errno)));
}

void Output::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void Output::flush() {
  if (std::fflush(file_.get()) != 0) fail();
}

void Output::close() {
  flush();
  if (!path_.empty() && std::fclose(file_.release()) != 0) fail();
}

Report::Report(const std::string& path, Format format, Provenance provenance)
    : format_(format), provenance_(std::move(provenance)), output_(path) {
  if (format_ == Format::csv) {
    output_.write(header(provenance_));
  } else if (format_ == Format::json) {
    document_["schema"] = fmt::format("stoss/{}/1", provenance_.schema);
    document_["version"] = version();
    document_["command"] = provenance_.command;
    document_["inputs"] = provenance_.inputs;
    document_["units"] = nlohmann::ordered_json::object();
    document_["records"] = nlohmann::ordered_json::array();
  }
  output_.flush();
}

void Report::begin(const std::vector<Entry>& record) {
  begun_ = true;
  if (format_ == Format::csv) {
    std::string text;
    for (const Entry& entry : record) {
      text += entry.unit.empty() ? entry.key : fmt::format("{}[{}]", entry.key, entry.unit);
      text += &entry == &record.back() ? "\n" : ",";
    }
    output_.write(text);
  } else if (format_ == Format::table) {
    std::string names;
    std::string units;
    for (const Entry& entry : record) {
      if (entry.width == 0) continue;
      names += right_aligned(entry.key, entry.width);
      units += right_aligned(entry.unit, entry.width);
    }
    units.erase(units.find_last_not_of(' ') + 1);
    output_.write(names + "\n" + units + "\n");
  } else {
    for (const Entry& entry : record) {
      if (!entry.unit.empty()) document_["units"][entry.key] = entry.unit;
    }
  }
}

void Report::add(const std::vector<Entry>& record) {
  if (!begun_) begin(record);
  if (format_ == Format::json) {
    nlohmann::ordered_json object;
    for (const Entry& entry : record) object[entry.key] = to_json(entry.value);
    document_["records"].push_back(std::move(object));
    return;
  }
  std::string text;
  for (const Entry& entry : record) {
    if (format_ == Format::csv) {
      text += full_precision(entry.value) + (&entry == &record.back() ? "" : ",");
    } else if (entry.width > 0) {
      text += right_aligned(entry.shown.empty() ? for_reading(entry.value) : entry.shown, entry.width);
    }
  }
  output_.write(text + "\n");
  output_.flush();
}

void Report::attach(const std::string& key, nlohmann::ordered_json value) { document_[key] = std::move(value); }

void Report::finish(bool complete) {
  if (format_ == Format::json) {
    document_["complete"] = complete;
    output_.write(document_.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  } else if (!complete) {
    output_.write("# interrupted: the rows above are complete, later ones are missing\n");
  }
  output_.close();
}

}  // namespace stoss::cli
