// Takes records from each rank to the ranks that they are meant for, and answers back.
#pragma once

#include <mpi.h>

#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

namespace swellflow {

/// What has come with a delivery or a reply. On one rank these are the sent records themselves, which must stay as they are as long as this is read.
template <class T> class Arrivals {
public:
  std::size_t size() const { return all_.size(); }
  bool empty() const { return all_.empty(); }
  const T &operator[](std::size_t i) const { return all_[i]; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  operator std::span<const T>() const { return all_; }

private:
  friend class Courier;
  void refer_to(const std::vector<T> &records) { all_ = records; }
  std::vector<T> &room(std::size_t n)
  {
    room_.resize(n);
    all_ = room_;
    return room_;
  }

  std::span<const T> all_;
  std::vector<T> room_;
};

/// LIGGGHTS' decomposition and the fluid's slabs are independent of each other, so any rank may have something for any other. All tell all how many records
/// will come, one number a pair; the records themselves go only where there are some.
class Courier {
public:
  explicit Courier(MPI_Comm comm) : comm_(comm)
  {
    MPI_Comm_size(comm, &ranks_);
    for (auto *counts : {&sent_, &received_, &sent_start_, &received_start_}) counts->assign(ranks_ + 1, 0);
    requests_.reserve(2 * ranks_);
  }

  /// records[i] goes to rank to[i]; those that arrive stand in the order of their senders. Collective.
  template <class T> void deliver(const std::vector<T> &records, const std::vector<int> &to, Arrivals<T> &arrived)
  {
    if (ranks_ == 1) return deliver_again(records, arrived);
    sort_by_rank(to);
    MPI_Alltoall(sent_.data(), 1, MPI_INT, received_.data(), 1, MPI_INT, comm_);
    std::exclusive_scan(received_.begin(), received_.end(), received_start_.begin(), 0);
    deliver_again(records, arrived);
  }

  /// More records from the same senders to the same receivers as in the last delivery. Collective.
  template <class T> void deliver_again(const std::vector<T> &records, Arrivals<T> &arrived)
  {
    if (ranks_ == 1) return arrived.refer_to(records);
    sort_records(records);
    std::vector<T> &room = arrived.room(received_start_[ranks_]);
    exchange(reinterpret_cast<const T *>(sorted_bytes_.data()), sent_, sent_start_, room.data(), received_, received_start_);
  }

  /// answers[i] belongs to arrived[i] of the last delivery; back[i] is the answer to records[i]. Collective.
  template <class T> void reply(const std::vector<T> &answers, Arrivals<T> &back)
  {
    if (ranks_ == 1) return back.refer_to(answers);
    sorted_bytes_.resize(place_.size() * sizeof(T));
    T *sorted = reinterpret_cast<T *>(sorted_bytes_.data());
    exchange(answers.data(), received_, received_start_, sorted, sent_, sent_start_);
    std::vector<T> &room = back.room(place_.size());
    for (std::size_t i = 0; i < place_.size(); ++i) room[i] = sorted[place_[i]];
  }

private:
  void sort_by_rank(const std::vector<int> &to)
  {
    std::fill(sent_.begin(), sent_.end(), 0);
    for (int rank : to) ++sent_[rank];
    std::exclusive_scan(sent_.begin(), sent_.end(), sent_start_.begin(), 0);
    next_ = sent_start_;
    place_.resize(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) place_[i] = next_[to[i]]++;
  }

  template <class T> void sort_records(const std::vector<T> &records)
  {
    sorted_bytes_.resize(records.size() * sizeof(T));
    T *sorted = reinterpret_cast<T *>(sorted_bytes_.data());
    for (std::size_t i = 0; i < records.size(); ++i) sorted[place_[i]] = records[i];
  }

  template <class T>
  void exchange(const T *out, const std::vector<int> &n_out, const std::vector<int> &out_start, T *in, const std::vector<int> &n_in,
                const std::vector<int> &in_start)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    requests_.clear();
    for (int r = 0; r < ranks_; ++r)
      if (n_in[r] > 0) MPI_Irecv(in + in_start[r], n_in[r] * static_cast<int>(sizeof(T)), MPI_BYTE, r, 0, comm_, new_request());
    for (int r = 0; r < ranks_; ++r)
      if (n_out[r] > 0) MPI_Isend(out + out_start[r], n_out[r] * static_cast<int>(sizeof(T)), MPI_BYTE, r, 0, comm_, new_request());
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  }
  MPI_Request *new_request()
  {
    requests_.push_back(MPI_REQUEST_NULL);
    return &requests_.back();
  }

  MPI_Comm comm_;
  int ranks_ = 1;
  std::vector<int> sent_, received_, sent_start_, received_start_, next_, place_;
  std::vector<unsigned char> sorted_bytes_;
  std::vector<MPI_Request> requests_;
};

}  // namespace swellflow
