// The grammar as the interpreter sees it: what #declare, #default and the geometry functions of
// expressions call back. One Grammar a scene; not thread-safe.
#pragma once

#include "parser/grammar/context.h"
#include "parser/interpreter/parser.h"

namespace lentray::parser {

class Grammar final : public Productions {
 public:
  Grammar();
  Context& context() { return m_context; }

  std::optional<Value> rvalue(Parser& parser) override;
  void set_default(Parser& parser) override;
  bool inside(const ObjectDesc& object, const core::Vec3& point) override;
  bool trace(const ObjectDesc& object, const core::Vec3& origin, const core::Vec3& direction,
             core::Vec3& point, core::Vec3& normal) override;
  void extent(const ObjectDesc& object, core::Vec3& lo, core::Vec3& hi) override;
  Ref<FunctionDesc> pattern_function(Parser& parser) override;

 private:
  Context m_context;
};

}  // namespace lentray::parser
