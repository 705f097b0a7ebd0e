"""The former name of crawling_scallop, for this version only."""
from crawling_scallop import *  # noqa: F401,F403
