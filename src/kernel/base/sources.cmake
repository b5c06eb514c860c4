list(APPEND SOARBOX_KERNEL_SOURCES base/random.cpp base/symbol_table.cpp base/symbol_text.cpp)
soarbox_kernel_test(kernel_base_test SOURCES base/random_test.cpp base/symbol_table_test.cpp)
