// Each array in a file: the length of its name, the name, the number of its values, its values.
#include "fluid/checkpoint.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace swellflow {

namespace {

constexpr int tag = 71;

/// One message may not be longer than this, in numbers.
constexpr std::size_t largest_message = std::size_t{1} << 26;

template <class Move> void in_messages(double *values, std::size_t count, const Move &move)
{
  for (std::size_t done = 0; done < count; done += largest_message) move(values + done, static_cast<int>(std::min(largest_message, count - done)));
}

void send(double *values, std::size_t count, int to, MPI_Comm comm)
{
  in_messages(values, count, [&](double *part, int n) { MPI_Send(part, n, MPI_DOUBLE, to, tag, comm); });
}

void receive(double *values, std::size_t count, int from, MPI_Comm comm)
{
  in_messages(values, count, [&](double *part, int n) { MPI_Recv(part, n, MPI_DOUBLE, from, tag, comm, MPI_STATUS_IGNORE); });
}

/// The intervals of all ranks, on rank 0.
std::vector<int> gathered(const Checkpoint::Part &part, int ranks, MPI_Comm comm)
{
  const int own[2] = {part.first, part.count};
  std::vector<int> all(2 * ranks);
  MPI_Gather(own, 2, MPI_INT, all.data(), 2, MPI_INT, 0, comm);
  return all;
}

bool agreed(bool good, MPI_Comm comm)
{
  int all = good;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, comm);
  return all;
}

}  // namespace

// ---- writing ---------------------------------------------------------------------------------------------------------------------------------

CheckpointWriter::CheckpointWriter(const std::string &file, MPI_Comm comm) : name_(file), comm_(comm)
{
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &ranks_);
  if (rank_ == 0) file_ = std::fopen(file.c_str(), "ab");
  if (!agreed(rank_ > 0 || file_, comm_)) throw std::runtime_error("cannot append to '" + file + "'");
}

CheckpointWriter::~CheckpointWriter()
{
  if (file_) std::fclose(file_);
}

void CheckpointWriter::close()
{
  if (file_) good_ = std::fclose(file_) == 0 && good_;
  file_ = nullptr;
  if (!agreed(good_, comm_)) throw std::runtime_error("cannot write all of '" + name_ + "'");
}

void CheckpointWriter::put(const void *data, std::size_t bytes)
{
  if (file_ && bytes > 0) good_ = std::fwrite(data, 1, bytes, file_) == bytes && good_;
}

void CheckpointWriter::begin(const std::string &name, std::size_t count)
{
  const auto length = static_cast<std::int64_t>(name.size()), values = static_cast<std::int64_t>(count);
  put(&length, sizeof length);
  put(name.data(), name.size());
  put(&values, sizeof values);
}

void CheckpointWriter::common(const std::string &name, double *values, int n)
{
  begin(name, n);
  put(values, n * sizeof(double));
}

void CheckpointWriter::parts(const std::string &name, double *values, int n, Of)
{
  std::vector<double> all(static_cast<std::size_t>(n) * ranks_);
  MPI_Gather(values, n, MPI_DOUBLE, all.data(), n, MPI_DOUBLE, 0, comm_);
  begin(name, all.size());
  put(all.data(), all.size() * sizeof(double));
}

void CheckpointWriter::array(const std::string &name, double *values, const Part &part)
{
  const std::vector<int> all = gathered(part, ranks_, comm_);
  begin(name, part.total * part.size);
  if (rank_ > 0) return send(values, part.count * part.size, 0, comm_);
  put(values, part.count * part.size * sizeof(double));
  std::vector<double> received;
  for (int r = 1; r < ranks_; ++r) {
    received.resize(all[2 * r + 1] * part.size);
    receive(received.data(), received.size(), r, comm_);
    put(received.data(), received.size() * sizeof(double));
  }
}

// ---- reading ---------------------------------------------------------------------------------------------------------------------------------

CheckpointReader::CheckpointReader(const std::string &file, long begin, long end, MPI_Comm comm) : name_(file), comm_(comm)
{
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &ranks_);
  if (rank_ == 0) file_ = std::fopen(file.c_str(), "rb");
  if (!agreed(rank_ > 0 || file_, comm_)) throw std::invalid_argument("cannot open '" + file + "'");
  if (file_) scan(begin, end);
  share_entries();
}

CheckpointReader::~CheckpointReader()
{
  if (file_) std::fclose(file_);
}

/// The file's checksum has been found right, so that what it says may be believed.
void CheckpointReader::scan(long begin, long end)
{
  std::fseek(file_, begin, SEEK_SET);
  while (std::ftell(file_) < end) {
    std::int64_t length = 0, count = 0;
    if (std::fread(&length, sizeof length, 1, file_) != 1 || length <= 0 || length > end) return;
    std::string name(length, ' ');
    if (std::fread(name.data(), 1, length, file_) != static_cast<std::size_t>(length) || std::fread(&count, sizeof count, 1, file_) != 1) return;
    entries_[name] = {std::ftell(file_), static_cast<std::size_t>(count)};
    std::fseek(file_, count * static_cast<long>(sizeof(double)), SEEK_CUR);
  }
}

/// All ranks know what there is.
void CheckpointReader::share_entries()
{
  std::string names;
  std::vector<double> counts;
  for (const auto &[name, entry] : entries_) {
    names += name + '\n';
    counts.push_back(static_cast<double>(entry.count));
  }
  int sizes[2] = {static_cast<int>(names.size()), static_cast<int>(counts.size())};
  MPI_Bcast(sizes, 2, MPI_INT, 0, comm_);
  names.resize(sizes[0]);
  counts.resize(sizes[1]);
  MPI_Bcast(names.data(), sizes[0], MPI_CHAR, 0, comm_);
  MPI_Bcast(counts.data(), sizes[1], MPI_DOUBLE, 0, comm_);
  if (rank_ == 0) return;
  std::size_t from = 0;
  for (const double count : counts) {
    const std::size_t to = names.find('\n', from);
    entries_[names.substr(from, to - from)] = {0, static_cast<std::size_t>(count)};
    from = to + 1;
  }
}

/// `count`: how many there must be, 0: any number.
const CheckpointReader::Entry &CheckpointReader::entry(const std::string &name, std::size_t count) const
{
  const auto found = entries_.find(name);
  if (found == entries_.end()) throw std::invalid_argument("'" + name_ + "' does not hold '" + name + "'");
  if (count > 0 && found->second.count != count)
    throw std::invalid_argument("'" + name_ + "' must hold " + std::to_string(count) + " values of '" + name + "', but holds " + std::to_string(found->second.count));
  return found->second;
}

void CheckpointReader::get(long at, double *values, std::size_t count)
{
  std::fseek(file_, at, SEEK_SET);
  if (std::fread(values, sizeof(double), count, file_) != count) std::fill_n(values, count, 0.0);
}

void CheckpointReader::common(const std::string &name, double *values, int n)
{
  const Entry &found = entry(name, n);
  if (file_) get(found.at, values, n);
  MPI_Bcast(values, n, MPI_DOUBLE, 0, comm_);
}

void CheckpointReader::parts(const std::string &name, double *values, int n, Of of)
{
  const Entry &found = entry(name, 0);
  std::vector<double> all(found.count);
  if (file_) get(found.at, all.data(), all.size());
  MPI_Bcast(all.data(), static_cast<int>(all.size()), MPI_DOUBLE, 0, comm_);
  if (all.size() == static_cast<std::size_t>(n) * ranks_) {
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(n) * rank_, n, values);
    return;
  }
  std::fill_n(values, n, 0.0);
  if (rank_ > 0) return;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double &value = values[i % n];
    value = of == Of::sum ? value + all[i] : i < static_cast<std::size_t>(n) ? all[i] : std::max(value, all[i]);
  }
}

void CheckpointReader::array(const std::string &name, double *values, const Part &part)
{
  const Entry &found = entry(name, part.total * part.size);
  const std::vector<int> all = gathered(part, ranks_, comm_);
  if (rank_ > 0) return receive(values, part.count * part.size, 0, comm_);
  const auto at = [&](int first) { return found.at + static_cast<long>(first * part.size * sizeof(double)); };
  get(at(part.first), values, part.count * part.size);
  std::vector<double> sent;
  for (int r = 1; r < ranks_; ++r) {
    sent.resize(all[2 * r + 1] * part.size);
    get(at(all[2 * r]), sent.data(), sent.size());
    send(sent.data(), sent.size(), r, comm_);
  }
}

}  // namespace swellflow
