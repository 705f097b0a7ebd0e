/* The functions of libconfig that the program uses, for a build without it (WITH_LIBCONFIG=0). config_read_string
 * refuses every text and explains why: such a program reads no scenes and no formula files, and has no settings. */
#ifndef SCALLOP_COMPARE_CONFIG_ABSENT_LIBCONFIG_H
#define SCALLOP_COMPARE_CONFIG_ABSENT_LIBCONFIG_H

typedef struct config_setting_t config_setting_t;
typedef struct {
  config_setting_t *root;
} config_t;
enum { CONFIG_TYPE_INT, CONFIG_TYPE_INT64, CONFIG_TYPE_FLOAT, CONFIG_TYPE_STRING, CONFIG_TYPE_BOOL, CONFIG_TYPE_LIST };

static inline void config_init(config_t *config) { config->root = 0; }
static inline void config_destroy(config_t *config) { config->root = 0; }

static inline int config_error_line(const config_t *config) { return config->root ? 0 : 1; }
static inline const char *config_error_text(const config_t *config)
{
  return config->root ? "" : "this program reads no scenes and no formula files: it was built without libconfig";
}

/* 0, unknown to the compiler: else it would warn of texts that are NULL. */
static volatile long config_nothing;
#define CONFIG_NOTHING(TYPE, NAME) \
  static inline TYPE NAME(const void *of, ...) { return (void)of, (TYPE)config_nothing; }
CONFIG_NOTHING(int, config_read_string)
CONFIG_NOTHING(config_setting_t *, config_root_setting)
CONFIG_NOTHING(config_setting_t *, config_setting_get_elem)
CONFIG_NOTHING(config_setting_t *, config_setting_get_member)
CONFIG_NOTHING(config_setting_t *, config_setting_add)
CONFIG_NOTHING(config_setting_t *, config_setting_set_string_elem)
CONFIG_NOTHING(const char *, config_setting_name)
CONFIG_NOTHING(const char *, config_setting_get_string)
CONFIG_NOTHING(int, config_setting_set_string)
CONFIG_NOTHING(int, config_setting_type)
CONFIG_NOTHING(int, config_setting_length)
CONFIG_NOTHING(int, config_setting_is_group)
CONFIG_NOTHING(int, config_setting_is_list)
CONFIG_NOTHING(int, config_setting_is_array)
CONFIG_NOTHING(int, config_setting_is_number)
CONFIG_NOTHING(int, config_setting_get_bool)
CONFIG_NOTHING(long long, config_setting_get_int64)
CONFIG_NOTHING(double, config_setting_get_float)
CONFIG_NOTHING(unsigned, config_setting_source_line)

#endif
