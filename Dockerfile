# The HTTP service in a container: docker build -t sketch2shape . && docker run --rm -p 8766:8766 sketch2shape
# Any other command: docker run --rm -v "$PWD:/work" -w /work sketch2shape drawing.png -o solid.stl
FROM python:3.12-slim
RUN useradd --create-home --uid 10001 sketch2shape
COPY pyproject.toml README.md LICENSE /source/
COPY sketch2shape /source/sketch2shape
RUN pip install --no-cache-dir '/source[ui,formats,connectors]' && rm -rf /source
USER sketch2shape
ENV PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1
EXPOSE 8766
HEALTHCHECK --interval=30s --timeout=5s CMD ["python", "-c", "import urllib.request as u; u.urlopen('http://127.0.0.1:8766/health', timeout=4)"]
ENTRYPOINT ["sketch2shape"]
CMD ["serve", "--host", "0.0.0.0"]
