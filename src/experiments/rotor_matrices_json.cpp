#include "experiments/rotor_matrices_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/nearest_name.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::array<std::string_view, 7> rotor_file_keys{"title", "M", "C", "G", "K", "bearing", "station"};
constexpr std::array<std::string_view, 4> place_keys{"name", "z", "x", "y"};

/// Reads the content of the file, and collects errors of its form.
class RotorFile {
 public:
  explicit RotorFile(const std::string& path) : path_(path) {
    json_ = nlohmann::json::parse(read_text_file(path), nullptr, false);
  }

  RotorMatrices read() {
    RotorMatrices matrices;
    if (json_.is_discarded() || !json_.is_object()) {
      error("", json_.is_discarded() ? "is not JSON" : "is not a JSON object",
            "give {\"M\": [[...], ...], \"C\": ..., \"G\": ..., \"K\": ..., \"bearing\": [...]}");
      throw_if_wrong();
    }
    check_names(json_, "", rotor_file_keys);
    rows("M", matrices.mass);
    rows("C", matrices.damping);
    rows("G", matrices.gyroscopic);
    rows("K", matrices.stiffness);
    places("bearing", true, matrices.bearings);
    places("station", false, matrices.stations);
    throw_if_wrong();
    errors_ = find_matrix_errors(matrices);
    for (InputError& one : errors_) one.file = path_;
    throw_if_wrong();
    return matrices;
  }

 private:
  void error(std::string key, std::string what, std::string advice) {
    errors_.push_back({path_, 0, std::move(key), "", std::move(what), std::move(advice)});
  }

  void throw_if_wrong() {
    if (!errors_.empty()) throw Error(ErrorKind::input, std::move(errors_));
  }

  template <std::size_t N>
  void check_names(const nlohmann::json& object, const std::string& holder,
                   const std::array<std::string_view, N>& known) {
    for (const auto& [name, value] : object.items()) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      const auto nearest = nearest_name(name, {known.begin(), known.end()});
      error(holder + name, "unknown key",
            nearest ? fmt::format("did you mean \"{}\"?", *nearest)
                    : fmt::format("known here: {}", fmt::join(known, ", ")));
    }
  }

  /// A square matrix, row by row.
  void rows(const std::string& key, std::vector<double>& entries) {
    const auto found = json_.find(key);
    if (found == json_.end()) return error(key, "is missing", "give it, of zeros where the rotor has none");
    if (!found->is_array()) return error(key, "is not a list of rows", "write [[...], [...], ...]");
    const std::size_t n = found->size();
    if (n > static_cast<std::size_t>(most_rotor_unknowns)) {
      return error(key, fmt::format("has {} rows", n),
                   fmt::format("give at most {}: reduce the rotor", most_rotor_unknowns));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const nlohmann::json& row = (*found)[i];
      const std::string name = fmt::format("{}[{}]", key, i + 1);
      const auto is_number = [](const nlohmann::json& one) { return one.is_number(); };
      if (!row.is_array() || !std::all_of(row.begin(), row.end(), is_number)) {
        error(name, "is not a list of numbers", "give a number for each column");
      } else if (row.size() != n) {
        error(name, fmt::format("has {} numbers, but there are {} rows", row.size(), n), "give a square matrix");
      } else {
        for (const nlohmann::json& one : row) entries.push_back(one.get<double>());
      }
    }
  }

  void places(const std::string& key, bool required, std::vector<MatrixPlace>& all) {
    const auto found = json_.find(key);
    if (found == json_.end()) {
      if (required)
        error(key, "is missing", "give two, such as {\"name\": \"drive end\", \"z\": 0.04, \"x\": 8, \"y\": 9}");
      return;
    }
    if (!found->is_array()) return error(key, "is no list", "write [{\"name\": ...}, ...]");
    if (found->size() > static_cast<std::size_t>(most_rotor_unknowns)) {
      return error(key, fmt::format("has {} entries", found->size()),
                   fmt::format("give at most {}", most_rotor_unknowns));
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
      const nlohmann::json& entry = (*found)[i];
      const std::string name = fmt::format("{}[{}]", key, i + 1);
      if (!entry.is_object()) {
        error(name, "is no object", "write {\"name\": \"drive end\", \"z\": 0.04, \"x\": 8, \"y\": 9}");
        continue;
      }
      check_names(entry, name + ".", place_keys);
      const auto part = [&](const char* what, bool right_kind, const char* kind) {
        if (entry.contains(what) && right_kind) return true;
        error(fmt::format("{}.{}", name, what), entry.contains(what) ? fmt::format("is no {}", kind) : "is missing",
              fmt::format("give a {}", kind));
        return false;
      };
      const auto of = [&entry](const char* what) -> const nlohmann::json& {
        static const nlohmann::json none;
        const auto held = entry.find(what);
        return held == entry.end() ? none : *held;
      };
      const auto counts = [](const nlohmann::json& one) {
        return one.is_number_integer() && one.get<double>() >= 0.0 && one.get<double>() < most_rotor_unknowns;
      };
      MatrixPlace place;
      if (part("name", of("name").is_string(), "text")) place.name = of("name").get<std::string>();
      if (part("z", of("z").is_number(), "number, m")) place.z = of("z").get<double>();
      if (part("x", counts(of("x")), "number of a row, from 0")) place.x = of("x").get<int>();
      if (part("y", counts(of("y")), "number of a row, from 0")) place.y = of("y").get<int>();
      all.push_back(std::move(place));
    }
  }

  std::string path_;
  nlohmann::json json_;
  std::vector<InputError> errors_;
};

}  // namespace

RotorMatrices read_rotor_matrices(const std::string& path) {
  return RotorFile(path).read();
}

}  // namespace bumpfoil
