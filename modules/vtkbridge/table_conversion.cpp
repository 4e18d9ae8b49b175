#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include "vtkbridge/core_conversion.h"
#include "vtkbridge/field_facts.h"
#include "vtkbridge/shared_arrays.h"

namespace bole::vtkbridge {
namespace {

static_assert(sizeof(long long) == sizeof(std::int64_t));

vtkSmartPointer<vtkStringArray> text_array(const std::vector<std::string>& texts) {
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i) array->SetValue(static_cast<vtkIdType>(i), texts[i]);
  return array;
}

vtkSmartPointer<vtkAbstractArray> table_column_to_vtk(const Table::NamedColumn& column,
                                                      const std::shared_ptr<const Table>& owner) {
  if (const auto* v = std::get_if<std::vector<double>>(&column.values))
    return shared_array<vtkDoubleArray>(v->data(), v->size(), 1, owner, column.name);
  if (const auto* v = std::get_if<std::vector<std::int64_t>>(&column.values))
    return shared_array<vtkLongLongArray>(v->data(), v->size(), 1, owner, column.name);
  auto array = text_array(std::get<std::vector<std::string>>(column.values));
  array->SetName(column.name.c_str());
  return array;
}

Table::Values numbers_from_vtk(vtkDataArray* array, int component) {
  const auto rows = static_cast<std::size_t>(array->GetNumberOfTuples());
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE) {
    std::vector<double> values(rows);
    for (std::size_t i = 0; i < rows; ++i) values[i] = array->GetComponent(static_cast<vtkIdType>(i), component);
    return values;
  }
  std::vector<std::int64_t> values(rows);
  for (std::size_t i = 0; i < rows; ++i)
    values[i] =
        array->GetVariantValue(static_cast<vtkIdType>(i) * array->GetNumberOfComponents() + component).ToTypeInt64();
  return values;
}

void add_column(Table& table, vtkAbstractArray* array, int number) {
  const std::string name = array->GetName() ? array->GetName() : "column_" + std::to_string(number);
  if (auto* numbers = vtkDataArray::SafeDownCast(array)) {
    const int components = numbers->GetNumberOfComponents();
    for (int c = 0; c < components; ++c)
      table.set(components == 1 ? name : name + "_" + std::to_string(c), numbers_from_vtk(numbers, c));
    return;
  }
  std::vector<std::string> texts(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < texts.size(); ++i)
    texts[i] = array->GetVariantValue(static_cast<vtkIdType>(i) * array->GetNumberOfComponents()).ToString();
  table.set(name, std::move(texts));
}

}  // namespace

void to_vtk(const std::shared_ptr<const Table>& table, vtkTable* out) {
  out->Initialize();
  for (const auto& column : table->columns()) out->AddColumn(table_column_to_vtk(column, table));
  set_facts(out, table->facts);
}

std::shared_ptr<const Table> table_from_vtk(vtkTable* vtk_table) {
  auto table = std::make_shared<Table>();
  for (int c = 0; c < static_cast<int>(vtk_table->GetNumberOfColumns()); ++c)
    add_column(*table, vtk_table->GetColumn(c), c);
  table->facts = get_facts(vtk_table);
  return table;
}

}  // namespace bole::vtkbridge
