#include "checkpoint_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>

#include "liggghts_version.h"

namespace swellflow {

namespace {

constexpr char magic[16] = "swellflow state";
constexpr std::int64_t format = 2;

/// The last bytes of a file; the checksum is of all that comes before it.
struct EndMark {
  char magic[16];
  std::int64_t format, fluid_begin, length;
  std::uint64_t checksum;
};
static_assert(sizeof(EndMark) == 48);

using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

[[noreturn]] void fail(const std::string &file, const std::string &reason) { throw std::runtime_error("'" + file + "': " + reason); }

std::uint64_t checksum_of(std::FILE *file, std::int64_t length)
{
  std::vector<unsigned char> buffer(1 << 20);
  std::uint64_t sum = crc32_z(0, nullptr, 0);
  std::fseek(file, 0, SEEK_SET);
  while (length > 0) {
    const std::size_t n = std::fread(buffer.data(), 1, std::min<std::int64_t>(length, buffer.size()), file);
    if (n == 0) return ~sum;
    sum = crc32_z(sum, buffer.data(), n);
    length -= static_cast<std::int64_t>(n);
  }
  return sum;
}

/// The version in the head of a restart file of LIGGGHTS; empty: this is none. Two integers, 0 and the length of the text, lead it.
std::string version_in(std::FILE *file)
{
  std::int32_t head[2] = {-1, 0};
  std::fseek(file, 0, SEEK_SET);
  if (std::fread(head, sizeof head, 1, file) != 1 || head[0] != 0 || head[1] <= 0 || head[1] > 1000) return "";
  std::string text(head[1], '\0');
  if (std::fread(text.data(), 1, text.size(), file) != text.size() || text.rfind("Version LIGGGHTS", 0) != 0) return "";
  return text;
}

void to_disk(const std::string &name)
{
  const int handle = open(name.c_str(), O_RDONLY);
  const bool done = handle >= 0 && fsync(handle) == 0;
  const int why = errno;
  if (handle >= 0) close(handle);
  if (!done) fail(name, std::strerror(why));
}

}  // namespace

bool is_unfinished(const std::string &file) { return file.ends_with(unfinished); }

void complete_checkpoint(const std::string &file, long fluid_begin)
{
  const File out(std::fopen(file.c_str(), "r+b"), std::fclose);
  if (!out) fail(file, std::strerror(errno));
  std::fseek(out.get(), 0, SEEK_END);
  EndMark mark{{}, format, fluid_begin, std::ftell(out.get()) + static_cast<std::int64_t>(sizeof(EndMark)), 0};
  std::memcpy(mark.magic, magic, sizeof magic);
  const std::int64_t before = mark.length - static_cast<std::int64_t>(sizeof mark);
  mark.checksum = crc32_z(checksum_of(out.get(), before), reinterpret_cast<unsigned char *>(&mark), offsetof(EndMark, checksum));
  std::fseek(out.get(), 0, SEEK_END);
  if (std::fwrite(&mark, sizeof mark, 1, out.get()) != 1 || std::fflush(out.get()) != 0) fail(file, std::strerror(errno));
  to_disk(file);
  checked_checkpoint(file);
}

void sync_folder(const std::string &of_file)
{
  const std::filesystem::path folder = std::filesystem::path(of_file).parent_path();
  to_disk(folder.empty() ? "." : folder.string());
}

CheckpointFile checked_checkpoint(const std::string &name)
{
  const auto refuse = [&name](const std::string &reason) {
    throw std::invalid_argument("a restart file must be complete and unchanged, but '" + name + "' " + reason + ": take another, such as the one before it");
  };
  const File file(std::fopen(name.c_str(), "rb"), std::fclose);
  if (!file) throw std::invalid_argument("a restart file must be readable, but '" + name + "' is not (" + std::strerror(errno) + "): check its name and folder");
  const std::string version = version_in(file.get());
  if (version.empty()) refuse("is no restart file of LIGGGHTS");
  EndMark mark{};
  std::fseek(file.get(), 0, SEEK_END);
  const std::int64_t size = std::ftell(file.get());
  const bool has_mark = size >= static_cast<std::int64_t>(sizeof mark) && std::fseek(file.get(), size - sizeof mark, SEEK_SET) == 0 &&
                        std::fread(&mark, sizeof mark, 1, file.get()) == 1 && std::memcmp(mark.magic, magic, sizeof magic) == 0;
  if (!has_mark) {
    if (version.find(version_mark) != std::string::npos) refuse("ends after " + std::to_string(size) + " bytes without the mark of its end, so that it was cut short");
    return {.name = name};
  }
  if (checksum_of(file.get(), size - sizeof mark.checksum) != mark.checksum) refuse("has another checksum than what is in it, so that it was damaged");
  if (mark.format != format) refuse("has format " + std::to_string(mark.format) + ", where this program knows " + std::to_string(format));
  return {.name = name, .fluid_begin = mark.fluid_begin, .fluid_end = size - static_cast<long>(sizeof mark), .checked = true};
}

// ---- names -----------------------------------------------------------------------------------------------------------------------------------

std::string with_step(const std::string &pattern, long step)
{
  std::string name = pattern;
  return name.replace(name.find('*'), 1, std::to_string(step));
}

std::vector<long> steps_of_files(const std::string &pattern)
{
  const std::filesystem::path path(pattern);
  const std::string name = path.filename().string();
  const std::size_t star = name.find('*');
  const std::string begin = name.substr(0, star), end = name.substr(star + 1);
  std::vector<long> steps;
  std::error_code ignored;
  for (const auto &entry : std::filesystem::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", ignored)) {
    const std::string file = entry.path().filename().string();
    if (file.size() <= begin.size() + end.size() || !file.starts_with(begin) || !file.ends_with(end)) continue;
    const char *first = file.data() + begin.size(), *last = file.data() + file.size() - end.size();
    long step = -1;
    if (const auto [stop, error] = std::from_chars(first, last, step); error == std::errc() && stop == last && step >= 0) steps.push_back(step);
  }
  std::sort(steps.rbegin(), steps.rend());
  return steps;
}

}  // namespace swellflow
