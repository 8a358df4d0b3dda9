// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/discovery.hpp"

#include <algorithm>
#include <cstring>
#include <thread>
#include <tuple>

#include "libcleave/internal/dds.hpp"

namespace cleave {
namespace {

constexpr std::size_t batch_size = 64;

struct Participant {
  dds_guid_t key;
  std::string process;
};

bool equal(const dds_guid_t& a, const dds_guid_t& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

std::string property(const dds_qos_t* qos, const char* name) {
  char* value = nullptr;
  if (qos == nullptr || !dds_qget_prop(qos, name, &value) || value == nullptr) return {};
  std::string text = value;
  dds_free(value);
  return text;
}

// Calls `visit` for everything that a built-in topic's reader holds.
template <class T, class Visit>
void for_each(dds_entity_t reader, Visit visit) {
  void* samples[batch_size] = {};
  dds_sample_info_t infos[batch_size];
  for (;;) {
    const dds_return_t count = dds_take(reader, samples, infos, batch_size, batch_size);
    if (count <= 0) return;
    for (dds_return_t i = 0; i < count; ++i) {
      if (infos[i].valid_data) visit(*static_cast<const T*>(samples[i]));
    }
    (void)dds_return_loan(reader, samples, count);
  }
}

std::vector<Participant> participants(dds_entity_t reader) {
  std::vector<Participant> found;
  for_each<dds_builtintopic_participant_t>(reader, [&](const auto& p) {
    std::string name = property(p.qos, "__ProcessName");
    const std::string id = property(p.qos, "__Pid");
    if (!id.empty()) name += " (" + id + ")";
    found.push_back({p.key, std::move(name)});
  });
  return found;
}

class DomainListener {
 public:
  DomainListener(dds_entity_t participant, Domain domain)
      : participant_(participant), domain_(domain) {
    const auto reader = [&](dds_entity_t topic) {
      return dds::Entity(dds_create_reader(participant, topic, nullptr, nullptr),
                         "cannot read DDS's built-in topics");
    };
    participants_ = reader(DDS_BUILTIN_TOPIC_DCPSPARTICIPANT);
    writers_ = reader(DDS_BUILTIN_TOPIC_DCPSPUBLICATION);
    readers_ = reader(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
  }

  void collect(std::vector<Endpoint>& endpoints) const {
    const std::vector<Participant> processes = participants(participants_.get());
    collect_from(writers_.get(), true, processes, endpoints);
    collect_from(readers_.get(), false, processes, endpoints);
  }

 private:
  void collect_from(dds_entity_t reader, bool writes, const std::vector<Participant>& processes,
                    std::vector<Endpoint>& endpoints) const {
    dds_guid_t self{};
    (void)dds_get_guid(participant_, &self);
    for_each<dds_builtintopic_endpoint_t>(reader, [&](const auto& e) {
      const std::string topic = e.topic_name;
      if (equal(e.participant_key, self) || topic.rfind("cleave/", 0) != 0) return;
      const auto process =
          std::find_if(processes.begin(), processes.end(),
                       [&](const Participant& p) { return equal(p.key, e.participant_key); });
      endpoints.push_back({domain_, writes, topic, e.type_name,
                           process == processes.end() ? std::string{} : process->process});
    });
  }

  dds_entity_t participant_;
  Domain domain_;
  dds::Entity participants_, writers_, readers_;
};

}  // namespace

std::string other_contract(const std::vector<Endpoint>& endpoints) {
  constexpr std::string_view ours = "cleave::v1::";  // the module of contract_name
  for (const Endpoint& e : endpoints) {
    if (!e.writes || e.type.starts_with(ours)) continue;
    return (e.process.empty() ? "a node" : e.process) + " publishes " + e.topic + " as " + e.type +
           ", which is another version of the contract than this program's " +
           std::string(contract_name) + ": install the same version of Cleave on both sides";
  }
  return {};
}

std::vector<Endpoint> discover(Stream& stream, std::chrono::milliseconds listen) {
  const DomainListener bulk(stream.bulk_participant(), Domain::bulk);
  const DomainListener public_listener(stream.public_participant(), Domain::public_domain);
  std::this_thread::sleep_for(listen);
  std::vector<Endpoint> endpoints;
  bulk.collect(endpoints);
  public_listener.collect(endpoints);
  std::sort(endpoints.begin(), endpoints.end(), [](const Endpoint& a, const Endpoint& b) {
    return std::tie(a.topic, b.writes, a.process) < std::tie(b.topic, a.writes, b.process);
  });
  return endpoints;
}

}  // namespace cleave
