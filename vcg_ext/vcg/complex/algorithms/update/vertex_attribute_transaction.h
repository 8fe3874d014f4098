// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCGLIB_VERTEX_ATTRIBUTE_TRANSACTION
#define VCGLIB_VERTEX_ATTRIBUTE_TRANSACTION

#include <vcg/complex/complex.h>

#include <memory>
#include <set>
#include <string>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <vector>

namespace vcg {
namespace tri {

/** \brief Named per-vertex attributes that a mesh gets all together, or none of them.

Adding an attribute takes memory and may fail. Until Commit() is called, leaving the scope takes back what was added; an
attribute of another type that bears the name is replaced by Commit(). Neither needs memory.
*/
template <class MeshType>
class VertexAttributeTransaction {
 public:
  template <class ValueType>
  using Handle = typename MeshType::template PerVertexAttributeHandle<ValueType>;

  /// \param attributes how many Attribute() will be asked for at most
  VertexAttributeTransaction(MeshType& m, size_t attributes) : m_(m)
  {
    added_.reserve(attributes);
    replacements_.reserve(attributes);
  }
  VertexAttributeTransaction(const VertexAttributeTransaction&) = delete;
  VertexAttributeTransaction& operator=(const VertexAttributeTransaction&) = delete;

  ~VertexAttributeTransaction()
  {
    for (const void* handle : added_) Remove(handle);
  }

  /// The attribute of that name. Its values must not be written before Commit().
  template <class ValueType>
  Handle<ValueType> Attribute(const std::string& name)
  {
    const Handle<ValueType> own = Allocator<MeshType>::template FindPerVertexAttribute<ValueType>(m_, name);
    if (Allocator<MeshType>::template IsValidHandle<ValueType>(m_, own)) return own;
    PointerToAttribute attribute;
    attribute._name = name;
    const Iterator other = m_.vert_attr.find(attribute);
    std::unique_ptr<SimpleTempDataBase> data(new SimpleTempData<typename MeshType::VertContainer, ValueType>(m_.vert));
    const Handle<ValueType> handle(data.get(), ++m_.attrn);
    if (other != m_.vert_attr.end()) {
      replacements_.push_back({other, std::move(data), int(sizeof(ValueType)), typeid(ValueType), m_.attrn});
      return handle;
    }
    Set(attribute, data.get(), int(sizeof(ValueType)), typeid(ValueType), m_.attrn);
    m_.vert_attr.insert(attribute);
    added_.push_back(data.release());
    return handle;
  }

  /// Keeps what was added, and replaces what is of another type. Never fails.
  void Commit()
  {
    added_.clear();
    for (Replacement& r : replacements_) {
      PointerToAttribute& attribute = const_cast<PointerToAttribute&>(*r.place);  // the name, its key, stays
      delete attribute._handle;
      Set(attribute, r.data.release(), r.size, r.type, r.number);
    }
    replacements_.clear();
  }

 private:
  using Iterator = typename std::set<PointerToAttribute>::iterator;

  struct Replacement {
    Iterator place;
    std::unique_ptr<SimpleTempDataBase> data;
    int size;
    std::type_index type;
    int number;
  };

  static void Set(PointerToAttribute& attribute, SimpleTempDataBase* data, int size, std::type_index type, int number)
  {
    attribute._handle = data;
    attribute._sizeof = size;
    attribute._padding = 0;
    attribute._type = type;
    attribute.n_attr = number;
  }

  void Remove(const void* handle)
  {
    for (Iterator i = m_.vert_attr.begin(); i != m_.vert_attr.end(); ++i)
      if (i->_handle == handle) {
        delete i->_handle;
        m_.vert_attr.erase(i);
        return;
      }
  }

  MeshType& m_;
  std::vector<const void*> added_;
  std::vector<Replacement> replacements_;
};

}  // namespace tri
}  // namespace vcg

#endif
