"""The REST service and the page: parameters in, studies out, nothing of physics."""
